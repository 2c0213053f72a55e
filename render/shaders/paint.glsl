// For fragment programs: the colour of the instance.
#if MAPPED
flat in vec4 v_color;
#else
#define v_color u_color
#endif
