/**
 * File access of programs: what they may read from the disk of the user who runs them. Open {@link
 * org.pendant.controller.file.ProgramsFolder} first.
 */
package org.pendant.controller.file;
