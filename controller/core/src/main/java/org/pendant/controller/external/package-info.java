/**
 * External connections: what a script reaches beyond its controller: the ways out are interfaces
 * that others implement, and what comes in is read here. Open {@link
 * org.pendant.controller.external.Connectors} first.
 */
package org.pendant.controller.external;
