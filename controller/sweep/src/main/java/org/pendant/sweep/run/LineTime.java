package org.pendant.sweep.run;

/**
 * Line time: how long a program was in one of its lines.
 *
 * @param line from 1
 * @param frames of 2 ms
 */
public record LineTime(int line, long frames) {}
