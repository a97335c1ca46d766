// SPDX-License-Identifier: MIT

// ---- Light or dark: as the system has it, until the reader chooses.
class Theme {
  constructor(button, onChange) {
    this.button = button;
    this.onChange = onChange;
    this.system = matchMedia('(prefers-color-scheme: dark)');
    this.system.addEventListener('change', () => this.set(this.system.matches));
    button.addEventListener('click', () => this.set(!this.dark));
    this.set(this.system.matches);
  }

  set(dark) {
    this.dark = dark;
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    this.button.textContent = dark ? 'Light' : 'Dark';
    this.onChange();
  }
}
