{%- for group in constants %}
{%- if !group.note.is_empty() %}
    /* {{ group.note }} */
{%- endif %}
{%- for member in group.constants %}
{%- match member.above("\n     * ") %}
{%- when Some with (above) %}
    /* {{ above }} */
    static const {{ member.ty }} {{ member.name }} = {{ member.value }};
{%- when None %}
    static const {{ member.ty }} {{ member.name }} = {{ member.value }}; /* {{ member.doc }} */
{%- endmatch %}
{%- endfor %}
{% endfor %}
