/**
 * Files with program trees as something to run, whatever their form. Open {@link
 * org.pendant.controller.program.file.TreeFile} first.
 */
package org.pendant.controller.program.file;
