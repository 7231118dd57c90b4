/**
 * The screen where programs are built as trees. Open {@link org.pendant.gui.program.TreeProgram}
 * first: one program, its history and what is generated from it; the screen itself is {@link
 * org.pendant.gui.program.ProgramView}.
 */
package org.pendant.gui.program;
