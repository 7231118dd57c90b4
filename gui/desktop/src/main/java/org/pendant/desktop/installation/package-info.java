/**
 * Installation screen: pages with forms, each for a part of the installation. Open {@link
 * org.pendant.desktop.installation.InstallationView} first.
 */
package org.pendant.desktop.installation;
