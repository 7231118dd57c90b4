package org.pendant.project.program.text;

/**
 * Text problem: something in a text that cannot be understood.
 *
 * @param line where it is, from 1
 * @param column where it begins, in characters from 1
 * @param message what was found and what would be right
 */
public record TextProblem(int line, int column, String message) {}
