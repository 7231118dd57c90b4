/**
 * Outgoing connections on behalf of scripts, as far as the user allows them. Open {@link
 * org.pendant.protocols.egress.HostPolicy} first.
 */
package org.pendant.protocols.egress;
