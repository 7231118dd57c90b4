package org.pendant.script.debug;

import java.util.OptionalInt;

/**
 * Breakpoint state: what became of a breakpoint.
 *
 * @param breakpoint as it was set
 * @param statementLine where the statement begins that it stops before: its own line or the nearest
 *     after it that has one; empty while no program runs, and after the last statement
 * @param hits how often this run came to it with its condition true
 */
public record BreakpointState(Breakpoint breakpoint, OptionalInt statementLine, long hits) {}
