/**
 * Ports of a control box, opened for the controller inside the desktop. Open {@link
 * org.pendant.desktop.ports.DesktopPorts} first; {@link org.pendant.desktop.ports.PortsView} is the
 * panel.
 */
package org.pendant.desktop.ports;
