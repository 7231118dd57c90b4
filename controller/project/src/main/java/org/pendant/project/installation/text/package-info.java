/**
 * Installations as text that people read and compare. Open {@link
 * org.pendant.project.installation.text.InstallationText} first.
 */
package org.pendant.project.installation.text;
