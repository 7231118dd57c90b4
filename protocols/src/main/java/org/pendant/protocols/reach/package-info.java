/**
 * Connecting to other computers on behalf of scripts, as far as the user allows. Open {@link
 * org.pendant.protocols.reach.Reach} first.
 */
package org.pendant.protocols.reach;
