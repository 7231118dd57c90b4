/**
 * Peers that send anything to the ports of a box. Open {@link
 * org.pendant.protocols.hostile.HostilePeersTest} first.
 */
package org.pendant.protocols.hostile;
