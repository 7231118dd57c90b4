/**
 * Program checks: what keeps a program tree from running. Open {@link
 * org.pendant.project.program.check.ProgramCheck} first.
 */
package org.pendant.project.program.check;
