/**
 * What servers get to work with: the controller, its frames, who may control it, and where to
 * listen.
 */
package org.pendant.protocols.server;
