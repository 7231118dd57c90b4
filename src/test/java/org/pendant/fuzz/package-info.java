/**
 * Random input. Texts on the way from text to motion end in diagnostics or in a program that runs,
 * never in a fault of our own: {@link org.pendant.fuzz.ScriptFuzzer}. Conversations with all ports
 * of a box leave nothing behind: {@link org.pendant.fuzz.SessionFuzzer}. Every build runs a moment
 * of both, {@code mvn -Pfuzz-texts} and {@code mvn -Pfuzz-sessions} run long.
 */
package org.pendant.fuzz;
