/**
 * Runs scripts: a compiler turns the syntax tree into compact instructions, a resumable machine
 * executes them frame by frame in script threads that are plain data. Open {@link
 * org.pendant.controller.vm.Machine} first, then {@link org.pendant.controller.vm.Processor} for
 * the instructions and {@link org.pendant.controller.vm.ProgramLoader} for the way from text to a
 * program.
 */
package org.pendant.controller.vm;
