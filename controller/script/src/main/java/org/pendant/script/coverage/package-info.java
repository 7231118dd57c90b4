/**
 * Coverage of programs: which places of a text can be reached, and which of them a run has reached.
 * Begin with {@link org.pendant.script.coverage.Coverage}.
 */
package org.pendant.script.coverage;
