/**
 * Program files: files with program trees as something to run, whatever their form. Open {@link
 * org.pendant.project.program.file.TreeFile} first.
 */
package org.pendant.project.program.file;
