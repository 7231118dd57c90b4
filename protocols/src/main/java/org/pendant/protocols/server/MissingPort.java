package org.pendant.protocols.server;

/**
 * Missing port: one that could not be opened.
 *
 * @param standardPort its number on a real box
 * @param why the message, which names protocol, address and port
 */
public record MissingPort(int standardPort, String why) {}
