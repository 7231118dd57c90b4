/**
 * Files of installations, of every form there is. Open {@link
 * org.pendant.controller.installation.file.InstallationFile} first.
 */
package org.pendant.controller.installation.file;
