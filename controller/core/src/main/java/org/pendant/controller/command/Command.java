package org.pendant.controller.command;

/**
 * Command: what a client asks of a controller. Each is a record of a sealed family that stands
 * beside its owner and is carried out by one {@link CommandHandler}, at the beginning of the next
 * frame or, while robot time stands, at once.
 */
public interface Command {}
