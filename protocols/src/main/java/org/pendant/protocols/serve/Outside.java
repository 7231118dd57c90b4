package org.pendant.protocols.serve;

import org.pendant.controller.Controller;
import org.pendant.protocols.net.FrameFan;
import org.pendant.protocols.net.PeerLog;

/**
 * What every server of one controller works with.
 *
 * @param controller takes commands and loads programs
 * @param frames hands out every snapshot
 * @param log the controller's log, bounded
 * @param remote who may control
 */
public record Outside(Controller controller, FrameFan frames, PeerLog log, RemoteControl remote) {}
