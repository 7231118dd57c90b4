/**
 * Installation files of every form there is. Open {@link
 * org.pendant.project.installation.file.InstallationFile} first.
 */
package org.pendant.project.installation.file;
