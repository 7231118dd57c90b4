package org.pendant.controller;

import java.util.concurrent.CompletableFuture;

/** A command on its way, and the place for its reply. */
record Submitted(Command command, CompletableFuture<Reply> reply) {}
