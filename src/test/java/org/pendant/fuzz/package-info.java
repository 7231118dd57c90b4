/**
 * Random texts for the way from text to motion: whatever is read ends in diagnostics or in a
 * program that runs, never in a fault of our own. Open {@link org.pendant.fuzz.ScriptFuzzer} first.
 */
package org.pendant.fuzz;
