package org.pendant.desktop.timeline;

/**
 * Pin: a moment of the last run at which the arm came nearest to one of its limits.
 *
 * @param timeS when, robot time, s
 * @param text what came how near, for people
 * @param used how much of the margin was used up, 0 to 1
 */
public record Pin(double timeS, String text, double used) {}
