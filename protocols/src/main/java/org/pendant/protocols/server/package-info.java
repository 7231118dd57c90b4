/**
 * Server context: the controller, its frames, which clients may control it, and where to listen.
 */
package org.pendant.protocols.server;
