/**
 * Program screen, where programs are built as trees. Open {@link
 * org.pendant.desktop.program.TreeProgram} first: one program, its history and what is generated
 * from it; the screen itself is {@link org.pendant.desktop.program.ProgramView}.
 */
package org.pendant.desktop.program;
