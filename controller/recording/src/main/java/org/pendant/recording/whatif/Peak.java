package org.pendant.recording.whatif;

/**
 * Peak: the most that was used of what the arm can do.
 *
 * @param share 1 for all of it
 * @param joint its name
 * @param line that the program was at
 * @param timeS robot time since the moment, s
 */
public record Peak(double share, String joint, int line, double timeS) {}
