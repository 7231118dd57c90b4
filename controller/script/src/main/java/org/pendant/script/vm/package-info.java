/**
 * Virtual machine for scripts: a compiler turns the syntax tree into compact instructions, a
 * resumable machine executes them frame by frame in script threads that are plain data. Open {@link
 * org.pendant.script.vm.Machine} first, then {@link org.pendant.script.vm.Processor} for the
 * instructions and {@link org.pendant.script.vm.ProgramLoader} for the way from text to a program.
 */
package org.pendant.script.vm;
