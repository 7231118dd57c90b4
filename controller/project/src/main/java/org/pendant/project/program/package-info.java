/**
 * Programs as trees of nodes, as they are made on a screen rather than typed. Open {@link
 * org.pendant.project.program.ProgramTree} and {@link org.pendant.project.program.Step} first. A
 * tree runs as the script that is generated from it.
 */
package org.pendant.project.program;
