// SPDX-License-Identifier: MIT
/**
 * @file How legible the texts of a page are: the contrast of each text with its background, from the browser's computed
 * styles. Formulas and limits of WCAG 2.2, criterion 1.4.3.
 */

/** @typedef {import('playwright-core').Page} Page */

/**
 * @typedef {object} Text
 * @property {string} text
 * @property {string} place the element with its classes or name
 * @property {number} contrast from 1 to 21
 * @property {number} least the required contrast: 4.5, or 3 for large text
 */

/**
 * All visible texts except those of disabled controls, for which there is no requirement.
 * @param {Page} page
 * @returns {Promise<Text[]>}
 */
export function readTexts(page) {
  return page.evaluate(() => {
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
      new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })
    );

    /** The sRGB colour, from 0 to 1, of layers painted over each other; the first is opaque. @param {string[]} layers */
    function painted(layers) {
      for (const layer of layers) {
        context.fillStyle = layer;
        context.fillRect(0, 0, 1, 1);
      }
      return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)].map((value) => value / 255);
    }

    /** @param {number[]} colour */
    function luminance(colour) {
      const [r, g, b] = colour.map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    }

    /** @param {number[]} a @param {number[]} b */
    function contrast(a, b) {
      const [dark, light] = [luminance(a), luminance(b)].sort((one, other) => one - other);
      return (light + 0.05) / (dark + 0.05);
    }

    /**
     * The possible backgrounds of an element: each is the list of colours of its ancestors, outermost first. A gradient
     * gives one background for each of its colours.
     * @param {Element} element
     * @returns {string[][]}
     */
    function grounds(element) {
      /** @type {string[][]} */
      let found = [['white']];
      /** @type {Element[]} */
      const chain = [];
      for (let at = /** @type {Element | null} */ (element); at; at = at.parentElement) chain.unshift(at);
      for (const { backgroundColor, backgroundImage } of chain.map((at) => getComputedStyle(at))) {
        const stops = backgroundImage.includes('gradient')
          ? (backgroundImage.match(/(rgba?|oklab|oklch|color)\([^()]*\)/g) ?? [])
          : [];
        found = found.map((layers) => [...layers, backgroundColor]);
        if (stops.length) found = found.flatMap((layers) => stops.map((stop) => [...layers, stop]));
      }
      return found;
    }

    /** @param {Element} element */
    function textOf(element) {
      if (element instanceof HTMLInputElement)
        return element.type === 'range' ? '' : element.value || element.placeholder;
      if (element instanceof HTMLSelectElement) return element.selectedOptions[0]?.text ?? '';
      const own = [...element.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE);
      return own
        .map((node) => node.textContent?.trim())
        .join(' ')
        .trim();
    }

    /** @param {Element} element */
    function isSeen(element) {
      if (!element.checkVisibility({ opacityProperty: true, visibilityProperty: true })) return false;
      const { width, height } = element.getBoundingClientRect();
      return width > 1 && height > 1;
    }

    const texts = [];
    for (const element of document.querySelectorAll('body *')) {
      const text = textOf(element);
      if (!text || element instanceof HTMLOptionElement || /^(checkbox|radio)$/.test(/** @type {any} */ (element).type))
        continue;
      if (element.closest('[aria-disabled=true], fieldset:disabled, script, style, noscript') || !isSeen(element))
        continue;
      const hint = element instanceof HTMLInputElement && !element.value;
      const style = getComputedStyle(element, hint ? '::placeholder' : null);
      const colour = element instanceof SVGElement ? style.fill : style.color;
      const worst = Math.min(
        ...grounds(element).map((layers) => contrast(painted(layers), painted([...layers, colour]))),
      );
      const size = parseFloat(style.fontSize);
      const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
      const names = [element.id && `#${element.id}`, element.getAttribute('class'), element.getAttribute('name')];
      texts.push({
        text: text.slice(0, 60),
        place: [element.tagName.toLowerCase(), ...names].filter(Boolean).join(' '),
        contrast: worst,
        least: large ? 3 : 4.5,
      });
    }
    return texts;
  });
}
