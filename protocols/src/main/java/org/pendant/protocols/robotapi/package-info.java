/**
 * Robot API of PolyScope X: robot and program by HTTP and JSON, to the same effect as the
 * dashboard. Open {@link org.pendant.protocols.robotapi.RobotApiServer} first, then {@code
 * RobotApiHandler}.
 */
package org.pendant.protocols.robotapi;
