/**
 * Connecting to other computers on behalf of scripts, as far as the user allows. Open {@link
 * org.pendant.protocols.egress.HostPolicy} first.
 */
package org.pendant.protocols.egress;
