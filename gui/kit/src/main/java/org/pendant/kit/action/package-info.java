/**
 * Actions: what people can do by key, menu or palette, and how keys read. Open {@link
 * org.pendant.kit.action.Action} first.
 */
package org.pendant.kit.action;
