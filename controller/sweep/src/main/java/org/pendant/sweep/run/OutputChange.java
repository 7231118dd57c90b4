package org.pendant.sweep.run;

/**
 * Output change: a digital signal that changed while a program ran.
 *
 * @param signal such as {@code digital_out[0]}
 * @param timeS since the start of the program
 */
public record OutputChange(String signal, boolean level, double timeS) {}
