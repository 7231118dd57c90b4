/**
 * Installations in the files of PolyScope, {@code .installation} and {@code .variables}. Open
 * {@link org.pendant.controller.installation.urp.UrInstallations} first.
 */
package org.pendant.controller.installation.urp;
