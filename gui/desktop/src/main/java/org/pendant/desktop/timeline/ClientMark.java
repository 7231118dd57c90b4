package org.pendant.desktop.timeline;

/**
 * Client mark: a message of a client of the ports that did something.
 *
 * @param timeS when it came, robot time, s
 * @param number of the message in the trace
 * @param text who and what
 */
public record ClientMark(double timeS, long number, String text) {}
