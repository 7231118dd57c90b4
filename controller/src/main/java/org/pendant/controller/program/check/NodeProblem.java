package org.pendant.controller.program.check;

/**
 * Why a program cannot run yet.
 *
 * @param key of the node that has to be changed
 * @param field of its form that it is about, as the component of the step's record is called; empty
 *     for the node as a whole
 * @param message what is missing or wrong, and what would be right
 */
public record NodeProblem(long key, String field, String message) {}
