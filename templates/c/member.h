{%- match member.above("\n     * ") %}
{%- when Some with (above) %}
    /* {{ above }} */
    {{ member.ty }} {{ member.name }};
{%- when None %}
    {{ member.ty }} {{ member.name }}; /* {{ member.doc }} */
{%- endmatch %}