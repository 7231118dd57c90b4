/**
 * Installations in the files of PolyScope, {@code .installation} and {@code .variables}. Open
 * {@link org.pendant.project.installation.urp.UrInstallations} first.
 */
package org.pendant.project.installation.urp;
