package org.pendant.protocols.server;

/**
 * A port that could not be had.
 *
 * @param standardPort its number on a real box
 * @param why the message, which names protocol, address and port
 */
public record MissingPort(int standardPort, String why) {}
