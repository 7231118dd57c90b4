/**
 * What programs may read from the disk of whoever runs them. Open {@link
 * org.pendant.controller.file.ProgramsFolder} first.
 */
package org.pendant.controller.file;
