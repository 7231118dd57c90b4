package org.pendant.protocols.server;

import org.pendant.controller.Robot;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;

/**
 * Server context: what the servers of one controller share.
 *
 * @param robot takes commands and loads programs
 * @param frames hands out every snapshot
 * @param log the controller's log, bounded
 * @param remote who may control
 */
public record ServerContext(
    Robot robot, StateBroadcaster frames, PeerLog log, RemoteControl remote) {}
