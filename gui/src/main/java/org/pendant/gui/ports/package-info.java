/**
 * The ports of a control box, opened for the controller inside the desktop. Open {@link
 * org.pendant.gui.ports.DesktopPorts} first; {@link org.pendant.gui.ports.PortsView} is the panel.
 */
package org.pendant.gui.ports;
