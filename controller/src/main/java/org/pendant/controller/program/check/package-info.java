/**
 * What keeps a program tree from running. Open {@link
 * org.pendant.controller.program.check.ProgramCheck} first.
 */
package org.pendant.controller.program.check;
