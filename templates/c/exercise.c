{%- if draws || !reals.is_empty() %}
/* next integer of the pseudo-random noise */
static uint32_t {{ owner }}_integer(uint32_t *random)
{
    *random = (*random * {{ Noise::FACTOR }}u + {{ Noise::SUMMAND }}u) % {{ Noise::RANGE }}u;
    return *random;
}
{% endif %}
{%- if is_scaled %}
/* a real sample of the noise; one in four is small */
static {{ real }} {{ owner }}_noise(uint32_t *random, {{ real }} scale)
{
    const uint32_t integer = {{ owner }}_integer(random);
    const {{ real }} noise = (({{ real }})integer - {{ Noise::HALF }}.0{{ suffix }}) * scale;
    return integer < {{ Noise::SMALL_BELOW }}u ? noise * {{ Noise::SMALL }}{{ suffix }} : noise;
}
{% endif %}
/* the digest after one more word */
static uint32_t {{ owner }}_fold(uint32_t digest, uint32_t word)
{
    return (((digest << 5) | (digest >> 27)) ^ word) * UINT32_C(0x9e3779b1);
}
{%- if self.folds_reals() %}

static uint32_t {{ owner }}_fold_real(uint32_t digest, {{ real }} value)
{
    union {
        {{ real }} value;
        uint{{ bits }}_t bits;
    } view;
    view.value = value;
{%- if bits == 64 %}
    return {{ owner }}_fold({{ owner }}_fold(digest, (uint32_t)view.bits), (uint32_t)(view.bits >> 32));
{%- else %}
    return {{ owner }}_fold(digest, view.bits);
{%- endif %}
}
{%- endif %}