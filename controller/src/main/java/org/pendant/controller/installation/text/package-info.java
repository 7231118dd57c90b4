/**
 * Installations as text that people read and compare. Open {@link
 * org.pendant.controller.installation.text.InstallationText} first.
 */
package org.pendant.controller.installation.text;
