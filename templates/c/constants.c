{%- for group in constants %}
{%- if !group.note.is_empty() %}
{{ margin }}/* {{ group.note }} */
{%- endif %}
{%- for member in group.constants %}
{%- match member.above(next_line) %}
{%- when Some with (above) %}
{{ margin }}/* {{ above }} */
{{ margin }}static const {{ member.ty }} {{ member.name }} = {{ member.value }};
{%- when None %}
{{ margin }}static const {{ member.ty }} {{ member.name }} = {{ member.value }}; /* {{ member.doc }} */
{%- endmatch %}
{%- endfor %}
{% endfor %}
