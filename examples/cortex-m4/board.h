/* What the program needs of the board. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

/* Starts the timer: it calls timer_interrupt so often per second. */
void board_start_timer(uint32_t per_second);

/* Waits for an interrupt. */
void board_sleep(void);

void board_put(const char *text);

void board_put_number(uint32_t number);

/* Written by the program. */
void timer_interrupt(void);
int main(void);

#endif
