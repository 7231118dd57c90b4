/**
 * Help: examples, documentation, keys and licences inside the window. Open {@link
 * org.pendant.desktop.help.HelpActions} first.
 */
package org.pendant.desktop.help;
