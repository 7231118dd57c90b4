/**
 * Program trees as text, one node a line; docs/program-files.md describes it. Open {@link
 * org.pendant.project.program.text.ProgramText} first.
 */
package org.pendant.project.program.text;
